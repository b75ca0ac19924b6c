#!/usr/bin/env bash
# Runs the Jobs beside this file one after another, and ends with the exit code of gq merge.
#   NAMESPACE=levels kubernetes/run.sh
# The volume must have the levels already. Run again, it does only what is missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
kubectl() { command kubectl --namespace "${NAMESPACE:-default}" "$@"; }

# until the Job has ended either way: `kubectl wait --for=condition=complete` would not notice a failure
ended() {
  local conditions
  while :; do
    conditions=$(kubectl get job "$1" --output 'jsonpath={.status.conditions[?(@.status=="True")].type}')
    case " $conditions " in
      *' Complete '*) return 0 ;;
      *' Failed '*) return 1 ;;
    esac
    sleep "${POLL_SECONDS:-10}"
  done
}

kubectl apply --filename volume.yaml

# the plan is made once: a new one would be of no use to results that are there
if ! kubectl get job gq-plan --output name >/dev/null 2>&1; then kubectl apply --filename plan.yaml; fi
if ! ended gq-plan; then
  kubectl logs job/gq-plan
  exit 2
fi

# a Job that has ended does not start again: it is deleted and made anew
kubectl replace --force --filename check.yaml
if ! ended gq-check; then
  echo "shards that failed: $(kubectl get job gq-check --output 'jsonpath={.status.failedIndexes}')" >&2
fi

# also where shards have failed: merge names what is missing
kubectl replace --force --filename merge.yaml
ended gq-merge || true
kubectl logs job/gq-merge
# the last pod: earlier ones lost their nodes
code=$(kubectl get pods --selector batch.kubernetes.io/job-name=gq-merge --sort-by .metadata.creationTimestamp \
  --output 'jsonpath={.items[-1:].status.containerStatuses[0].state.terminated.exitCode}')
exit "${code:-2}"
