#ifndef coapt_base_serialization_h
#define coapt_base_serialization_h

// What boost::serialization has to know about the standard library; needed
// where an object is written to an archive or read from one.
#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#endif
