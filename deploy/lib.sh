# deploy/lib.sh: what the scripts of this folder share: messages, long steps with a log, where things are.
# shellcheck shell=bash

shopt -s inherit_errexit # an error inside $(...) ends the script too
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck disable=SC2034 # for the scripts that read this file
log_dir=$root/build/log jobs=$(nproc)
step_group=

say() { printf '%s\n' "$*"; }

# One line on stderr, exit code 2: the command cannot do its work.
die() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 2
}

# The comment at the top of a script, as its help.
usage() { sed -n -e '2,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$0"; }

# Ends the long step that is under way, with all its children.
stop_step() {
  [[ -z $step_group ]] || kill -TERM -- "-$step_group" 2>/dev/null || true
}
trap stop_step EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# The last words of a log that somebody may want to see while it grows, cut to one line.
last_line() { tail -n 1 "$1" 2>/dev/null | tr -d '\r' | cut -c 1-100; }

# Waits until the process $1 ends; every 20 s says how long it has taken and the last line of the log $2.
watch_step() {
  local begin=$SECONDS said=$SECONDS
  while kill -0 "$1" 2>/dev/null; do
    sleep 0.5
    if ((SECONDS - said >= 20)); then
      said=$SECONDS
      say "   $((SECONDS - begin)) s: $(last_line "$2")"
    fi
  done
}

# step NAME COMMAND...: runs a long command with its output in build/log/NAME.log; says how far it is, how
# long it took, and on failure the end of the log. Returns the command's code.
step() {
  local name=$1 log=$log_dir/$1.log begin=$SECONDS code=0
  shift
  mkdir -p "$log_dir"
  say "-- $name ..."
  set -m # a process group of its own, so that stop_step reaches all its children
  "$@" >"$log" 2>&1 </dev/null &
  step_group=$!
  set +m
  watch_step "$step_group" "$log"
  wait "$step_group" || code=$?
  step_group=
  if ((code == 0)); then
    say "-- $name: done in $((SECONDS - begin)) s"
  else
    say "-- $name: FAILED after $((SECONDS - begin)) s, exit code $code; the end of $log:"
    tail -n 40 "$log"
  fi
  return "$code"
}

# build_targets PRESET [TARGET...]: builds the named targets, or all.
build_targets() {
  local preset=$1
  shift
  (cd "$root" && cmake --build --preset "$preset" -j "$jobs" ${1:+--target "$@"})
}

# test_counts LOG: "total failed skipped" of one run of ctest. A test that was skipped or could not be
# started counts as skipped; ctest itself calls the former passed.
test_counts() {
  local total failed skipped
  total=$(sed -n 's/.* tests failed out of \([0-9]*\)$/\1/p' "$1" | tail -n 1)
  failed=$(sed -n 's/.* tests passed, \([0-9]*\) tests failed out of .*/\1/p' "$1" | tail -n 1)
  skipped=$(grep -cE '\*\*\*(Skipped|Not Run)' "$1" || true)
  echo "${total:-0} ${failed:-0} $skipped"
}

# failure_output LOG: what each failed test said, as ctest printed it with its result; at most 60 lines each.
failure_output() {
  awk '
    /^ *[0-9]+\/[0-9]+ Test +#/ { left = /\*\*\*(Failed|Timeout|Exception)/ ? 60 : 0 }
    /^ +Start +[0-9]+:/ { next }
    left > 0 { print; --left }' "$1"
}

# closing_line TOTAL FAILED: in ctest's own words.
closing_line() {
  local percent=0
  (($1 == 0)) || percent=$((100 * ($1 - $2) / $1))
  say "$percent% tests passed, $2 tests failed out of $1"
}
