import type { Feature } from '../feature.ts';
import { ConflictDialog } from './ConflictDialog.tsx';
import { followDisagreement } from './follow-disagreement.ts';
import './conflicts.css';

/** What to do when the page and the file on disk disagree. */
export const conflicts: Feature = { name: 'conflicts', dialogs: ConflictDialog, start: followDisagreement };
