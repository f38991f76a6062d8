# Largest difference of the stresses in a table of the task biaxial from the
# homogeneous ones over the largest of these; fails above 1e-4, or if there are not as
# many rows as states.
function absolute(x) { return x < 0 ? -x : x }
NR > 1 {
  ++rows
  for (i = 4; i <= 5; ++i) {
    if ($i !~ /^[-0-9.e+]+$/) { print "row " NR ": " $i; bad = 1 }
    if (absolute($i - $(i + 2)) > difference) difference = absolute($i - $(i + 2))
    if (absolute($(i + 2)) > largest) largest = absolute($(i + 2))
  }
}
END {
  if (rows != states) { print rows + 0 " rows instead of " states; exit 1 }
  if (largest == 0 || bad) { print "no stresses"; exit 1 }
  printf "%g", difference / largest
  exit difference / largest > 1e-4
}
