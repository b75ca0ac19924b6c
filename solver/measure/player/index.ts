export { type FitInterval, fitPlayers, type ObservedAttempt, type PlayerFit } from './fit.ts';
export { type PlayerParameters, UNCALIBRATED } from './parameters.ts';
export type { PlayedAttempt } from './player.ts';
export {
  createPlayers,
  type ForecastAttempt,
  type PlayerForecast,
  type PlayerOptions,
  type PlayerPopulation,
  type PlayerShare,
  playAsPlayers,
} from './population.ts';
