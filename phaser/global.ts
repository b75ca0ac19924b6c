// What a script tag puts into the global `GravityQuest`: see build-script.mjs.
export * from '../game/index.ts';
export * from './index.ts';
