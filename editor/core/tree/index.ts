export { InlineName } from './InlineName.tsx';
export { MoreButton, Tree } from './Tree.tsx';
export { leavesBetween, type MenuEntry, type Modifiers, type TreeRow, toggledIn } from './tree-rows.ts';
