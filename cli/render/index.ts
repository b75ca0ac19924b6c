export {
  type View,
  viewAllRuns,
  viewExploration,
  viewFan,
  viewProof,
  viewRun,
  viewSoftlocks,
  viewSolved,
} from '../commands/render/views.ts';
