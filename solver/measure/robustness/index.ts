export { BRIEF_CERTIFY_RUNS, type Certification, type CertifyOptions, certify, certifyInSteps } from './certify.ts';
export { measureRobustness, measureRobustnessInSteps, type Robustness, type RobustnessOptions } from './robustness.ts';
export { clustersOf, ShiftBox, shiftsUpTo } from './shift-box.ts';
export { type EdgeSlack, findSlack, findSlackInSteps, SLACK_LIMIT, slackOf } from './slack.ts';
export {
  countSuccesses,
  type SampleOptions,
  type Success,
  successInSteps,
  successProbability,
  toSuccess,
  wilsonInterval,
  Z_90,
} from './success-probability.ts';
export {
  drawShift,
  extremeNoise,
  FIRST_TO_CHOOSE_BY,
  mirroredShift,
  normalBeyondHalf,
  type TickNoise,
  tickNoise,
  uniformOf,
} from './tick-noise.ts';
export { createTrials, judgeAll, playFrom, shiftHolds, type Trials } from './trials.ts';
