export { InlineName } from './InlineName.tsx';
export { MoreButton } from './MoreButton.tsx';
export { Tree } from './Tree.tsx';
export type { Modifiers } from './tree-props.ts';
export { leavesBetween, type MenuEntry, type TreeRow, toggledIn } from './tree-rows.ts';
