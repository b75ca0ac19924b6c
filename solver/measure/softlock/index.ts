export type { LostPlace, RunLoss, Standing, SurveyedState } from './standing.ts';
export { createSoftlockSurvey, LIVES_ON, type SoftlockSurvey, type SurveyOptions } from './survey.ts';
