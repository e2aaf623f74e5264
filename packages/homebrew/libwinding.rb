# A formula for Homebrew: libwinding alone. The program needs tinygltf, which Homebrew lacks.
#
# It was not run. Ruby has checked its syntax, and tests/packages/recipes_test.py runs it with
# Homebrew's methods replaced. The project has no public address: the address is a placeholder, and
# ./dev release writes a copy with the hash of the archive that it makes.
class Libwinding < Formula
  desc "Winding-number fields of surfaces and point clouds, for C"
  homepage "https://archive.invalid"
  url "https://archive.invalid/winding-1.0.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license "BSD-3-Clause"

  depends_on "cmake" => :build
  depends_on "eigen" => :build
  depends_on "nanoflann" => :build
  depends_on "highway"

  def install
    system "cmake", "-S", ".", "-B", "build", *std_cmake_args,
           "-DWINDING_LIBRARY_ONLY=ON", "-DWINDING_TESTS=OFF"
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    (testpath/"test.c").write <<~C
      #include <winding.h>
      int main(void) { return winding_version() == 0; }
    C
    system ENV.cc, "test.c", "-I#{include}", "-L#{lib}", "-lwinding", "-o", "test"
    system "./test"
  end
end
