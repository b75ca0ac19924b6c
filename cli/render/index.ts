export { type Subject, type View, viewAllRuns, viewExploration, viewFan, viewProof, viewRun, viewSolved } from './views.ts';
