export { clickAgain, clickAt, hitsOf } from './click.ts';
export { listenToPointer, type PointerListening } from './listen.ts';
export { DRAGGED_TOOL, listenToDrops, placeFor } from './place-object.ts';
export { CLICK_SLOP, type LastClick, type PointerContext, type PointerInput } from './state.ts';
