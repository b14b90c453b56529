#!/bin/sh
# running, success or failed: the state of Slurm job $1, from the controller or, when it has forgotten the job,
# from the accounting where there is one.
state=$(scontrol -o show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p')
[ -n "$state" ] || state=$(sacct -j "$1" --noheader --parsable2 --format=State 2>/dev/null | head -n 1)
case "$state" in
  COMPLETED*) echo success ;;
  PENDING* | CONFIGURING* | RUNNING* | COMPLETING* | SUSPENDED* | REQUEUED* | PREEMPTED*) echo running ;;
  *) echo failed ;;
esac
