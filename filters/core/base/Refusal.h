#pragma once

#include <stdexcept>

namespace winding
{

/**
 * Thrown where input or parameters cannot be worked with. what() is one line for the user, which
 * says what is wrong, where, and what to do about it. Nothing is left allocated or changed.
 */
class Refusal : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace winding
