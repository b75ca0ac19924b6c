#!/usr/bin/env bash
# Submits plan, shards and merge, each after the one before it, and prints the ids of the jobs.
#   aws-batch/submit.sh          everything
#   aws-batch/submit.sh again    shards and merge: with the plan that is there, after a failure
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

submit() {
  local file=$1
  shift
  aws batch submit-job --cli-input-json "file://$file" --query jobId --output text "$@"
}

after=()
case ${1:-all} in
  all)
    plan=$(submit plan.json)
    echo "plan   $plan"
    after=(--depends-on "jobId=$plan")
    ;;
  again) ;;
  *)
    echo "expected nothing or again, found $1" >&2
    exit 2
    ;;
esac
check=$(submit check.json ${after[@]+"${after[@]}"})
echo "check  $check"
merge=$(submit merge.json --depends-on "jobId=$check")
echo "merge  $merge"
