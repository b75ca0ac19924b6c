import { useRef, useState } from 'react';
import { Button, Dialog } from '../../core/ui/index.ts';
import { TextArea, type TextAreaHandle } from './TextArea.tsx';
import { TextProblems } from './TextProblems.tsx';
import { TextRefusal } from './TextRefusal.tsx';
import { useLevelText } from './use-level-text.ts';

interface TextDialogProps {
  readonly id: string;
  /** Edits the file on disk, even if the level is open. */
  readonly fromDisk?: boolean;
  readonly onClose: () => void;
}

/** Edits a level as text, above all an invalid one. Only a valid level replaces the file on disk. */
export function TextDialog({ id, fromDisk = false, onClose }: TextDialogProps) {
  const level = useLevelText(id, fromDisk, onClose);
  const { base, text, setText, isDirty, problems, isUnreadable, error, newer, save } = level;
  const [isLeaving, setIsLeaving] = useState(false);
  const area = useRef<TextAreaHandle>(null);
  const where = base?.etag === null ? 'in the editor' : 'on disk';
  const leave = () => (isDirty && !isLeaving ? setIsLeaving(true) : onClose());

  return (
    <Dialog open wide title={`${id}.level.json`} about="The level as text. It can only be saved if it is valid." onClose={leave}>
      {base === null && error === null && !isUnreadable && <p>Reading…</p>}
      {base !== null && (
        <TextArea
          ref={area}
          label="Text of the level"
          text={text}
          problems={problems}
          onChange={setText}
          onSave={() => void save(null)}
        />
      )}
      {(base !== null || isUnreadable) && (
        <TextProblems problems={problems} onGoTo={(line, column) => area.current?.goTo(line, column)} />
      )}
      <TextRefusal level={level} where={where} />
      <div className="form__buttons">
        {isLeaving && <span className="astext__leaving">Your changes are not saved.</span>}
        <Button hint={isLeaving ? 'Discard your changes' : 'Close'} look={isLeaving ? 'danger' : 'outlined'} onClick={leave}>
          {isLeaving ? 'Discard' : 'Close'}
        </Button>
        <Button
          hint={problems.length > 0 ? 'Fix the listed problems first' : newer !== null ? 'Choose a version first' : 'Save'}
          shortcut="Ctrl S"
          look="main"
          disabled={!isDirty || problems.length > 0 || base === null || newer !== null}
          onClick={() => void save(null)}
        >
          {base?.etag === null ? 'Apply' : 'Save and open'}
        </Button>
      </div>
    </Dialog>
  );
}
