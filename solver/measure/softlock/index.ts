export type { LostPlace, RunLoss, Standing, SurveyedState } from './standing.ts';
export { createSoftlockSurvey, type SoftlockSurvey, type SurveyOptions } from './survey.ts';
export { LIVES_ON } from './survey-steps.ts';
