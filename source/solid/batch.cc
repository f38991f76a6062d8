#include <coapt/solid/batch.h>

// This file alone is compiled with relaxed arithmetic, with which the compiler
// takes such loops from the C library's vector functions (libmvec).
namespace coapt
{
  namespace internal
  {
    void
    square_roots(Batch &x)
    {
      for (unsigned int i = 0; i < batch_size; ++i)
        x[i] = std::sqrt(x[i]);
    }



    void
    exponentials(Batch &x)
    {
      for (unsigned int i = 0; i < batch_size; ++i)
        x[i] = std::exp(x[i]);
    }



    void
    logarithms(Batch &x)
    {
      for (unsigned int i = 0; i < batch_size; ++i)
        x[i] = std::log(x[i]);
    }



    void
    cube_roots(Batch &x)
    {
      for (unsigned int i = 0; i < batch_size; ++i)
        x[i] = std::cbrt(x[i]);
    }
  } // namespace internal
} // namespace coapt
