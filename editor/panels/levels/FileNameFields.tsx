import { useId } from 'react';
import { LEVEL_ID_PART } from '../../../schema/index.ts';
import { FolderSelect } from './FolderSelect.tsx';
import { inFolder } from './level-files.ts';

/** What is wrong with a name for a file; null: nothing. @param taken ids of other levels */
export function fileNameProblem(folder: string, stem: string, taken: readonly string[]): string | null {
  if (!LEVEL_ID_PART.test(stem)) return 'letters, digits, - _ and spaces inside, at most 80; it begins with a letter or a digit';
  const id = inFolder(folder, stem).toLowerCase();
  return taken.some((other) => other.toLowerCase() === id) ? 'another level has this file name' : null;
}

interface FileNameFieldsProps {
  readonly stem: string;
  readonly folder: string;
  /** What is wrong with the name, as `fileNameProblem` has it. */
  readonly problem: string | null;
  /** Why the server would not have it. */
  readonly refusal?: string | null;
  readonly onStem: (stem: string) => void;
  readonly onFolder: (folder: string) => void;
}

/** The name of a level's file and its folder, and what is wrong with them. */
export function FileNameFields({ stem, folder, problem, refusal = null, onStem, onFolder }: FileNameFieldsProps) {
  const field = useId();
  return (
    <>
      <label htmlFor={`${field}-file`}>Name of the file</label>
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
