import { Button } from '../../ui/index.ts';
import type { LevelText } from './use-level-text.ts';

interface TextRefusalProps {
  readonly level: LevelText;
  /** Where the level is: in the editor, on the disk. */
  readonly where: string;
}

/** Why a text could not be saved, and what there is to choose from where somebody else has changed the level meanwhile. */
export function TextRefusal({ level, where }: TextRefusalProps) {
  const { error, newer, theirs, isValid, take, save } = level;
  if (error === null && theirs === null) return null;
  return (
    <div className="astext__refusal" role="alert">
      <p>
        {error !== null && newer === null
          ? `${error.message}. ${error.hint}.`
          : `The level was changed ${where} meanwhile. What was typed here is kept, and rests on what was there before.`}
      </p>
      {theirs !== null && (
        <>
          <Button hint="Drop what was typed here" look="outlined" onClick={() => take(theirs)}>
            Take what is {where}
          </Button>
          <Button hint={`Replace what is ${where}`} look="danger" disabled={!isValid} onClick={() => void save(theirs.etag)}>
            Save over it
          </Button>
        </>
      )}
    </div>
  );
}
