// Interpolation by a time table: exact at the rows and for straight lines, no
// overshoot, held at both ends, units; and the refusal of malformed tables.
#include <coapt/base/exceptions.h>
#include <coapt/base/time_table.h>
#include <coapt/base/units.h>

#include "tests.h"

#include <fstream>

using namespace coapt;

void
write(const std::string &text)
{
  std::ofstream("table.csv") << text;
}

// the reason for which the table is refused, without the file's name
template <typename Make>
std::string
refusal(const Make &make)
{
  try
    {
      make();
    }
  catch (const InputError &error)
    {
      return error.what();
    }
  return "accepted";
}

void
expect_refusal(const std::string &what,
               const std::string &text,
               const std::string &unit = "from file")
{
  write(text);
  std::cout << what << " -> "
            << refusal([&] { TimeTable::from_file("table.csv", unit); })
            << std::endl;
}

void
check_interpolation()
{
  const TimeTable line({0, 1, 3, 4}, {1, 3, 7, 9});
  double error = 0;
  for (double t = 0; t <= 4; t += 0.01)
    error = std::max(error, std::abs(line(t) - (1 + 2 * t)));
  check("straight line is exact", error < 1e-13, error);

  check("largest magnitude",
        TimeTable({0, 1, 2}, {1, -3, 2}).largest_magnitude() == 3);

  // a step up and a plateau: between its neighbours everywhere
  const TimeTable step({0, 1, 1.1, 2, 5}, {0, 0, 10, 10, 4});
  bool monotone = true;
  for (double t = 0; t < 1.99; t += 0.005)
    monotone = monotone && step(t + 0.005) >= step(t) - 1e-14;
  for (double t = 2; t < 4.99; t += 0.005)
    monotone = monotone && step(t + 0.005) <= step(t) + 1e-14;
  check("monotone between the rows", monotone);
  check("no overshoot", step(1.6) == 10 && step(0.5) == 0);
  check("held before and after", step(-3) == 0 && step(50) == 4);

  // the smooth function sin(t), up to pi/2: error falls as h^3 or better
  double errors[2];
  for (const unsigned int level : {0, 1})
    {
      const unsigned int n = 10 << level;
      std::vector<double> times(n + 1), values(n + 1);
      for (unsigned int i = 0; i <= n; ++i)
        values[i] = std::sin(times[i] = 1.5 * i / n);
      const TimeTable table(times, values);
      errors[level] = 0;
      for (double t = 0; t < 1.5; t += 0.001)
        errors[level] = std::max(errors[level], std::abs(table(t) - sin(t)));
    }
  check("error of a smooth curve below 2e-4", errors[1] < 2e-4, errors[1]);
  check("order of a smooth curve at least 2",
        errors[0] / errors[1] > 4,
        errors[0] / errors[1]);
}

void
check_units_and_formats()
{
  write("# a comment\n\ntime_s, pressure_mmHg\n0,0.1\n 0.01 , 17.5 # late\n");
  const TimeTable mmHg = TimeTable::from_file("table.csv");
  check_relative("mmHg by header", mmHg(0.01), 2333.1417798, 1e-9);
  write("0,0\n1,2");
  check_relative("kPa by parameter",
                 TimeTable::from_file("table.csv", "kPa")(1),
                 2000,
                 1e-14);
  write("\"Time [s]\",\"p [kPa]\"\r\n0,0\r\n1,2\r\n");
  check_relative("quoted header, Windows line ends",
                 TimeTable::from_file("table.csv")(1),
                 2000,
                 1e-14);
  const TimeTable list = TimeTable::from_list("0:0.1, 0.01:17.5", "mmHg");
  check("list and file agree", list(0.004) == mmHg(0.004));
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_interpolation();
  check_units_and_formats();

  std::cout << refusal([] { TimeTable::from_file("absent.csv"); }) << std::endl;
  expect_refusal("empty", "# nothing\n");
  expect_refusal("header only", "time_s,p_Pa\n");
  expect_refusal("one row", "time_s,p_Pa\n0,1\n");
  expect_refusal("truncated row", "time_s,p_Pa\n0,1\n1,2\n2");
  expect_refusal("no value", "time_s,p_Pa\n0,1\n1,\n");
  expect_refusal("three columns", "time_s,p_Pa\n0,1\n1,2,3\n");
  expect_refusal("text", "time_s,p_Pa\n0,1\nend,2\n");
  expect_refusal("not finite", "time_s,p_Pa\n0,1\n1,nan\n");
  expect_refusal("not increasing", "time_s,p_Pa\n0,1\n1,2\n1,3\n");
  expect_refusal("no unit", "0,1\n1,2\n");
  expect_refusal("unknown unit", "time_s,p_bar\n0,1\n1,2\n");
  expect_refusal("two units", "time_s,p_kPa\n0,1\n1,2\n", "mmHg");
  std::cout << refusal([] { TimeTable::from_list("0:1, 1"); }) << std::endl;
  std::cout << refusal([] { TimeTable::from_list(""); }) << std::endl;
}
