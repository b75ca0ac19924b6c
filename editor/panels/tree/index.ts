export { InlineName } from './InlineName.tsx';
export { MoreButton } from './MoreButton.tsx';
export { type Modifiers, Tree } from './Tree.tsx';
export { leavesBetween, type MenuEntry, type TreeRow } from './tree-rows.ts';
