export { CanvasView } from './CanvasView.tsx';
export { rendererOf } from './page-stage.ts';
export { DRAGGED_TOOL } from './pointer/index.ts';
