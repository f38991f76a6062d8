# Reads the statistics of a drained valve. With what = "held_and_reopened" asserts that
# from 60 to 70 ms it is shut, tight and carried by contact, that it reopens without a
# burst while some of what had drained flows back, and that it is open at 110 ms; with
# "leaks" that it leaks in its last 10 ms.
FNR == 1 {
  for (i = 1; i <= NF; ++i) column[$i] = i
  next
}

function value(name) { return $column[name] }

# Volume past the leaflets, mL.
function passed() {
  return value("outflow_volume_mL") + value("drained_volume_mL") - value("swept_volume_mL")
}

function require(name, condition, x) {
  printf("%s: %g%s\n", name, x, condition ? "" : "  NOT SO")
  if (!condition) failed = 1
}

{
  time = value("time_s")
  last_time = time
  last_passed = passed()
  if (time < start[what] - 1e-9) next
  if (!begun) { begun = 1; first_time = time; first_passed = last_passed }
}

what == "held_and_reopened" && time < 0.0701 {
  force += value("coaptation_force_N")
  contact += value("contact_force_N")
  if (value("widest_path_mm") > widest) widest = value("widest_path_mm")
  held_time = time
  held_passed = last_passed
  held_drained = value("drained_volume_mL")
}

what == "held_and_reopened" && time > 0.0701 && value("velocity_max_m_per_s") > fastest {
  fastest = value("velocity_max_m_per_s")
}

BEGIN { start["held_and_reopened"] = 0.06; start["leaks"] = 0.05 }

END {
  if (what == "leaks") {
    leak = (last_passed - first_passed) / (last_time - first_time)
    require("leak of short leaflets, mL/s", leak > 20, leak)
    exit failed
  }
  require("share of contact", contact > 0.85 * force, contact / force)
  require("widest path, mm, below half a cell", widest < 0.39, widest)
  leak = (held_passed - first_passed) / (held_time - first_time)
  # The last films still drain.
  require("leak, mL/s", leak < 2.5, leak)
  require("no contact at the end, N", value("contact_force_N") == 0, value("contact_force_N"))
  require("open at the end, mm", value("widest_path_mm") > 1.5, value("widest_path_mm"))
  require("largest velocity while it reopens, m/s", fastest < 3, fastest)
  require("flows back into films, mL", held_drained > value("drained_volume_mL"),
          held_drained - value("drained_volume_mL"))
  require("energy error", value("energy_error_relative") < 0.01,
          value("energy_error_relative"))
  exit failed
}
