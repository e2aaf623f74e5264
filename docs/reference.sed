# What Doxygen reads in place of a header.

# "#V by 3" is a shape, not a link.
s,^( *(///|/\*\*|\*).*[ (])#([A-Za-z]),\1\\#\3,

# Every VTK class has these two, which need no words in each header.
s,^  static vtk[A-Za-z]*\* New\(\);,  /** A new object\, whose reference is the caller's. */&,
s,^  void PrintSelf\(.*,  /** Prints all properties and results. */&,

# Users of a VTK class see what is public. What is protected has its comments in the header.
/^class VTK[A-Z]*WINDING_EXPORT/,/^};/ {
  /^(protected|private):/,/^};/ {
    /^};/!d
  }
}
