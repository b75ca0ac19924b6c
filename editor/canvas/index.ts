export { CanvasView } from './CanvasView.tsx';
export { signOf } from './kinds/index.ts';
export { objectChanges } from './object-changes.ts';
export { rendererOf } from './page-stage.ts';
export { DRAGGED_TOOL } from './pointer/index.ts';
export { poseAt } from './run-pose.ts';
export { transformActions } from './selection-box/index.ts';
