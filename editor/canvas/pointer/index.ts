export { DRAGGED_TOOL, listenToDrops } from './drop.ts';
export { listenToPointer, type PointerListening } from './listen.ts';
export { CLICK_SLOP, type PointerContext, type PointerInput } from './state.ts';
