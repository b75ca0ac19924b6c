import type { Editor } from '../context/index.ts';
import { type Answer, errorInWords, type StorageError } from '../files/index.ts';

/** Shows a notice about a failure. */
export function tellError({ notices }: Editor, error: StorageError): void {
  notices.show('warning', errorInWords(error), { topic: 'level-files' });
}

/** The value of an answer; for a refusal null, and a notice says why. */
export function valueOrNotice<T>(editor: Editor, answer: Answer<T>): T | null {
  if (answer.ok) return answer.value;
  tellError(editor, answer.error);
  return null;
}
