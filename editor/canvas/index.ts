export { CanvasView } from './CanvasView.tsx';
export { signOf } from './kinds/index.ts';
export { rendererOf } from './page-stage.ts';
export { DRAGGED_TOOL } from './pointer/index.ts';
export { poseAt } from './run-pose.ts';
