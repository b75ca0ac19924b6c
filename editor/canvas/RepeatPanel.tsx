import { useEffect, useRef, useState } from 'react';
import { useLevel } from '../core/context/index.ts';
import { type Gesture, MOST_COPIES, type Repetition, repeatObjects, unlocked } from '../core/document/index.ts';
import { Segments } from '../core/panel/index.ts';
import { Button, NumberField } from '../core/ui/index.ts';
import { centreOf, extentOf } from './extent.ts';

/** px; no copy is farther away than this */
const FAR = 1e6;

interface Fields {
  readonly along: Repetition['along'];
  readonly copies: number;
  readonly dx: number;
  readonly dy: number;
  readonly x: number;
  readonly y: number;
  readonly degrees: number;
}

const repetitionOf = ({ along, copies, dx, dy, x, y, degrees }: Fields): Repetition =>
  along === 'line' ? { along, copies, dx, dy } : { along, copies, centre: { x, y }, degrees };

/** What the fields say at first: a step of the selection's width to the right, a centre as far below. */
function firstFields(level: ReturnType<typeof useLevel>): Fields {
  const keys = level.selection.keys();
  const box = extentOf(level.document.file(), level.proof.proof().scene.box, keys);
  const at = box === null ? { x: 0, y: 0 } : centreOf(box);
  const width = box === null ? 64 : Math.round(box.right - box.left);
  const { blackHole } = level.document.file();
  const centre = keys.length === 1 && keys[0] === '@blackHole' ? at : blackHole;
  return { along: 'line', copies: 3, dx: width + 32, dy: 0, x: centre.x, y: centre.y, degrees: 360 };
}

/** Repeats the selection along a line or around a centre. The copies are shown while the figures are chosen. */
export function RepeatPanel({ onClose }: { readonly onClose: () => void }) {
  const level = useLevel();
  const { document: edited, selection } = level;
  const [keys] = useState(() => unlocked(edited.file(), selection.keys()));
  const [fields, setFields] = useState(() => firstFields(level));
  const [problem, setProblem] = useState<string | null>(null);
  const gesture = useRef<Gesture | null>(null);
  const added = useRef<readonly string[]>([]);
  const panel = useRef<HTMLDivElement>(null);

  useEffect(() => {
    const mine = edited.begin('Repeat');
    gesture.current = mine;
    panel.current?.querySelector('input')?.focus();
    return () => mine.cancel();
  }, [edited]);
  useEffect(() => {
    const now = gesture.current;
    if (now === null) return;
    // an undo or a change on disk has ended it
    if (!now.isLive) {
      onClose();
      return;
    }
    const result = now.set(repeatObjects(keys, repetitionOf(fields)));
    if (result.ok) added.current = result.added;
    setProblem(result.ok ? null : `${result.refusal.message}. ${result.refusal.hint}`);
  }, [fields, keys, onClose]);

  const set = (name: keyof Fields) => (value: number) => setFields((now) => ({ ...now, [name]: value }));
  const number = (name: 'dx' | 'dy' | 'x' | 'y' | 'degrees' | 'copies', label: string, unit?: string) => (
    <NumberField
      label={label}
      value={fields[name]}
      min={name === 'copies' ? 1 : name === 'degrees' ? -360 : -FAR}
      max={name === 'copies' ? MOST_COPIES : name === 'degrees' ? 360 : FAR}
      whole={name === 'copies'}
      unit={unit}
      onChange={set(name)}
    />
  );
  const done = () => {
    const copies = added.current;
    gesture.current?.commit();
    selection.select([...keys, ...copies]);
    onClose();
  };
  return (
    <div
      ref={panel}
      className="canvas__panel"
      data-keeps-clear
      role="dialog"
      aria-modal={false}
      aria-label="Repeat the selection"
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        onClose();
      }}
    >
      <Segments
        label="Copies stand"
        value={fields.along}
        options={[
          { value: 'line', title: 'in a line', about: 'Each copy is one step farther.' },
          { value: 'circle', title: 'in a circle', about: 'Copies are turned about the centre.' },
        ]}
        onChange={(along) => setFields((now) => ({ ...now, along: along as Fields['along'] }))}
      />
      {number('copies', 'copies')}
      {fields.along === 'line' ? (
        <>
          {number('dx', 'step x', 'px')}
          {number('dy', 'step y', 'px')}
        </>
      ) : (
        <>
          {number('degrees', 'angle °', '°')}
          {number('x', 'centre x', 'px')}
          {number('y', 'centre y', 'px')}
        </>
      )}
      {problem !== null && (
        <p className="form__problem" role="alert">
          {problem}
        </p>
      )}
      <div className="canvas__does">
        <Button hint="Close without copies" shortcut="Esc" look="outlined" onClick={onClose}>
          Cancel
        </Button>
        <Button hint="Keep the copies" look="main" disabled={problem !== null} onClick={done}>
          Repeat
        </Button>
      </div>
    </div>
  );
}
