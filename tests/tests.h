#ifndef coapt_tests_h
#define coapt_tests_h

#include <coapt/base/exceptions.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

/**
 * Prints "<what>: ok" on the first rank if @p condition holds on every rank,
 * and otherwise the measured @p value with its bound, so that the text
 * differs from the reference output and the test fails.
 */
inline void
check(const std::string &what, const bool condition, const double value = 0)
{
  const bool ok =
    dealii::Utilities::MPI::min(condition ? 1 : 0, MPI_COMM_WORLD) == 1;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      if (ok)
        std::cout << what << ": ok" << std::endl;
      else
        std::cout << what << ": FAILED, value " << value << std::endl;
    }
}

/** Checks |value - expected| <= tolerance * max(1e-300, |expected|). */
inline void
check_relative(const std::string &what,
               const double value,
               const double expected,
               const double tolerance)
{
  check(what,
        std::abs(value - expected) <= tolerance * std::abs(expected),
        value);
}

/** The message of the InputError that @p action throws, "none" without one. */
template <typename Action>
std::string
error_of(const Action &action)
{
  try
    {
      action();
    }
  catch (const coapt::InputError &error)
    {
      return error.what();
    }
  return "none";
}

#endif
