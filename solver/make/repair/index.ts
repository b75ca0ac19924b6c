export { applyChange, type Change, changeEdits, changeSize, type LevelEdit, type ObjectRef, type Vector } from './change.ts';
export type { Proposal, RunOrigin } from './proposal.ts';
export { createRepair, type Repair, type RepairOptions } from './repair.ts';
