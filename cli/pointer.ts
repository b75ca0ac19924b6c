import { pointerFile } from '../schema/json/index.ts';
import { Failure } from './failure.ts';
import { namedPath } from './shown-path.ts';

/**
 * Refuses a file that only says where its content is, as Git LFS leaves it.
 * @param expected what the file should be, in words
 * @param head its bytes, or the first of them if it is longer than a kilobyte
 * @throws Failure that says how to get the content
 */
export function refusePointer(path: string, expected: string, head: Uint8Array): void {
  const pointer = pointerFile(head);
  if (pointer === null) return;
  throw new Failure(`${namedPath(path)}: expected ${expected}, found ${pointer.found}. ${pointer.hint}`);
}
