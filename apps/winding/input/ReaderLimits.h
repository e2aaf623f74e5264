#pragma once

#include <cstdint>

/**
 * Limits this process to what reading a file of `fileSize` bytes can need. Memory beyond that is
 * refused with std::bad_alloc; after too much processor time the process is ended by SIGPROF.
 */
void limitToReading(std::uintmax_t fileSize);
