export { type Certification, type CertifyOptions, certify } from './certify.ts';
export { measureRobustness, type Robustness } from './robustness.ts';
export { judgeAll } from './script-tree.ts';
export { clustersOf, ShiftBox, shiftsUpTo } from './shift-box.ts';
export { shiftHolds } from './shift-holds.ts';
export { type EdgeSlack, findSlack, slackByEdge } from './slack.ts';
export { countSuccesses, type SampleOptions, type Success, successProbability, toSuccess } from './success-probability.ts';
export { drawShift, extremeNoise, normalBeyondHalf, type TickNoise, tickNoise, uniformOf } from './tick-noise.ts';
export { createTrials, type Trials } from './trials.ts';
