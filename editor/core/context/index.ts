export * from './context.tsx';
export { FINGER, IS_MAC, mediaOf, useCoarse, useMedia, usePageTheme, useTouch } from './device.ts';
export { type Analysis, attemptGhosts, type Editor, type Ghost, type OpenLevel, type Pose, putGhosts } from './editor.ts';
