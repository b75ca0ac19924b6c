export { DRAGGED_TOOL, listenToDrops } from './drop.ts';
export { listenToPointer, type PointerListening } from './listen.ts';
export type { PointerContext } from './state.ts';
