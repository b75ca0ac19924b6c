export type { LostPlace, RunLoss, Standing, SurveyedState } from './state.ts';
export { createSoftlockSurvey, LIVES_ON, type SoftlockSurvey, type SurveyOptions } from './survey.ts';
