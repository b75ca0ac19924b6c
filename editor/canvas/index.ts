export { CanvasView } from './CanvasView.tsx';
export type { Ghost } from './layers/way-layer.ts';
export { rendererOf } from './page-stage.ts';
export { DRAGGED_TOOL } from './pointer/index.ts';
export type { Pose } from './pose.ts';
