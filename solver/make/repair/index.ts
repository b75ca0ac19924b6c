export { applyChange, type Change, changeEdits, changeSize, type LevelEdit, type ObjectRef, type Vector } from './change.ts';
export { createRepair, type Repair, type RepairOptions } from './repair.ts';
export type { Proposal, RunOrigin } from './task.ts';
