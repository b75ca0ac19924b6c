export { type CollectedPlays, collectPlays, type LevelPlays } from './collect-plays.ts';
