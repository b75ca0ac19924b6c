import { errorInWords } from '../../core/files/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { LevelText } from './use-level-text.ts';

interface TextRefusalProps {
  readonly level: LevelText;
  /** Where the other version is: in the editor, on disk. */
  readonly where: string;
}

/** Why a text could not be saved, and the choices if the level has changed in the meantime. */
export function TextRefusal({ level, where }: TextRefusalProps) {
  const { error, newer, theirs, isValid, take, save } = level;
  if (error === null && theirs === null) return null;
  return (
    <div className="astext__refusal" role="alert">
      <p>
        {error !== null && newer === null
          ? errorInWords(error)
          : `The level was changed ${where} in the meantime. Your text is kept; it is based on the previous version.`}
      </p>
      {theirs !== null && (
        <>
          <Button hint="Discard your text" look="outlined" onClick={() => take(theirs)}>
            Use the version {where}
          </Button>
          <Button hint={`Replace the version ${where}`} look="danger" disabled={!isValid} onClick={() => void save(theirs.etag)}>
            Overwrite
          </Button>
        </>
      )}
    </div>
  );
}
