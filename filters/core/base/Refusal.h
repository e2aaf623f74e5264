#pragma once

#include <stdexcept>

namespace winding
{

/**
 * Thrown where input or parameters cannot be worked with. what() is one line for the user: what is
 * wrong, where, and what to do about it. Nothing has been allocated or changed when it is thrown.
 */
class Refusal : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace winding
