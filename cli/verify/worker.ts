export { replayAll as default } from './replay.ts';
