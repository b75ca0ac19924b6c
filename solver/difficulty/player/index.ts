export { type FitInterval, fitPlayers, type ObservedAttempt, type PlayerFit } from './fit.ts';
export { type PlayerParameters, UNCALIBRATED } from './parameters.ts';
export { edgesOf, Player } from './player.ts';
export {
  createPlayers,
  type ForecastAttempt,
  type PlayerForecast,
  type PlayerOptions,
  type PlayerPopulation,
  type PlayerShare,
} from './population.ts';
export { practiceTable, timeRun } from './timing.ts';
