#!/usr/bin/env bash
# check_killed.sh MPIEXEC PROGRAM CASE FOLDER: kills one of two ranks of a run
# with SIGKILL. The other one must end too, and the run with an error.
set -uo pipefail
mpiexec=$1 program=$2 case=$3 folder=$4
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1
cat "$case" - >case.prm <<END
subsection Time
  set End time = 10
end
subsection Output
  set Folder = results
end
END
# A name of its own, so that the ranks of this run can be found.
name=coapt_$(basename "$folder")
ln -s "$program" "$name"
"$mpiexec" -np 2 "./$name" case.prm >log 2>&1 &
run=$!
for ((i = 0; i < 60; ++i)); do
  [ -f results/statistics.csv ] || [ -f results/run_1/statistics.csv ] && break
  sleep 1
done
victim=$(pgrep -f "^\./$name case.prm" | tail -n 1)
if [ -z "$victim" ]; then
  echo "The run did not start:"
  cat log
  exit 1
fi
kill -9 "$victim"
for ((i = 0; i < 30; ++i)); do
  kill -0 $run 2>/dev/null || break
  sleep 1
done
if kill -0 $run 2>/dev/null || pgrep -f "^\./$name case.prm" >/dev/null; then
  echo "Ranks go on after one has been killed."
  kill -9 $run $(pgrep -f "^\./$name case.prm")
  exit 1
fi
if wait $run; then
  echo "The run reports success."
  exit 1
fi
