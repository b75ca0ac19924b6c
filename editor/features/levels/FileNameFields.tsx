import { useId } from 'react';
import { LEVEL_ID_PART } from '../../../schema/index.ts';
import { inFolder } from '../../core/levels/index.ts';
import { FolderSelect } from '../../core/panel/index.ts';

/** What is wrong with a file name; null if nothing. @param taken ids of other levels */
export function fileNameProblem(folder: string, stem: string, taken: readonly string[]): string | null {
  if (!LEVEL_ID_PART.test(stem))
    return 'use letters, digits, -, _ and spaces, at most 80 characters, beginning with a letter or a digit';
  const id = inFolder(folder, stem).toLowerCase();
  return taken.some((other) => other.toLowerCase() === id) ? 'another level has this file name' : null;
}

interface FileNameFieldsProps {
  readonly stem: string;
  readonly folder: string;
  /** What is wrong with the name, from `fileNameProblem`. */
  readonly problem: string | null;
  /** Why the server refused the name. */
  readonly refusal?: string | null;
  readonly onStem: (stem: string) => void;
  readonly onFolder: (folder: string) => void;
}

/** The fields for a level's file name and folder, with what is wrong with them. */
export function FileNameFields({ stem, folder, problem, refusal = null, onStem, onFolder }: FileNameFieldsProps) {
  const field = useId();
  return (
    <>
      <label htmlFor={`${field}-file`}>File name</label>
      <span className="form__file">
        <input
          id={`${field}-file`}
          className="field"
          value={stem}
          spellCheck={false}
          aria-invalid={problem !== null}
          aria-describedby={problem === null ? undefined : `${field}-problem`}
          onChange={(event) => onStem(event.target.value)}
        />
        .level.json
      </span>
      <FolderSelect value={folder} onChange={onFolder} />
      {(problem ?? refusal) !== null && (
        <p id={`${field}-problem`} className="form__problem" role="alert">
          {problem ?? refusal}
        </p>
      )}
    </>
  );
}
