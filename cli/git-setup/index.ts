export { missing, type OnBrokenRun, setUp, undo } from './set-up.ts';
