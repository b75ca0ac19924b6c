export {
  type View,
  viewAllRuns,
  viewExploration,
  viewFan,
  viewProof,
  viewRun,
  viewSoftlocks,
  viewSolved,
} from './views.ts';
