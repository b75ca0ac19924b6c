export { ConflictDialog } from './ConflictDialog.tsx';
export { followDisagreement } from './follow-disagreement.ts';
