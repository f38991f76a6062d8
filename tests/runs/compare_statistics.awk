# Compares two files of statistics column by column: the largest difference must
# be at most 1e-9 of the column's largest value, or of a millionth of its unit
# where the whole column is smaller than that, as round-off is.
function absolute(x) { return x < 0 ? -x : x }

FNR == 1 {
  ++file
  if (file == 1) { header = $0; columns = split($0, name, ",") }
  else if ($0 != header) { print "The columns differ."; failed = 1 }
  next
}

file == 1 {
  rows = FNR
  for (i = 1; i <= columns; ++i) {
    value[FNR, i] = $i
    if (absolute($i) > scale[i]) scale[i] = absolute($i)
  }
}

file == 2 {
  last = FNR
  for (i = 1; i <= columns; ++i) {
    # what is not a number equals itself only as text
    difference = $i == value[FNR, i] ? 0 : absolute($i - value[FNR, i])
    if (!(difference <= largest[i])) largest[i] = difference
  }
}

END {
  if (rows < 2 || rows != last) { print "Rows: " rows " and " last; failed = 1 }
  for (i = 1; i <= columns; ++i) {
    if (scale[i] < 1e-6) scale[i] = 1e-6
    ok = largest[i] / scale[i] <= 1e-9
    if (!ok) failed = 1
    printf("%-30s scale %-10.3g relative difference %.2g%s\n", name[i], scale[i],
           largest[i] / scale[i], ok ? "" : "  TOO LARGE")
  }
  exit failed
}
