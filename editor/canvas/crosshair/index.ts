export { type Crosshair, createCrosshair } from './crosshair.ts';
export { arrowsWith, CROSSHAIR_HELP, crosshairCommands, stepOf } from './crosshair-commands.ts';
