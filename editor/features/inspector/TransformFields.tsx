import { FlipHorizontal2, FlipVertical2, Grid3x3, RotateCw, Scaling } from 'lucide-react';
import { useMemo, useState } from 'react';
import { objectChanges, transformActions } from '../../canvas/index.ts';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { Section } from '../../core/panel/index.ts';
import { Button, NumberField } from '../../core/ui/index.ts';

/** Turns the selection by typed degrees, scales it by a typed percentage, mirrors and repeats it. */
export function TransformFields() {
  const editor = useEditor();
  const level = useLevel();
  const actions = useMemo(() => transformActions(level, objectChanges(editor, level)), [editor, level]);
  const [degrees, setDegrees] = useState(90);
  const [percent, setPercent] = useState(200);
  const [withRadii, setWithRadii] = useState(false);
  return (
    <Section title="Transform">
      <div className="transform">
        <NumberField label="turn °" value={degrees} min={-360} max={360} onChange={setDegrees} />
        <Button hint={`Turn by ${degrees}°`} icon={<RotateCw size={16} />} onClick={() => actions.turn(degrees)} />
        <NumberField label="scale %" value={percent} min={1} max={10_000} onChange={setPercent} />
        <Button
          hint={`Scale to ${percent} %`}
          icon={<Scaling size={16} />}
          onClick={() => actions.scale(percent / 100, withRadii)}
        />
      </div>
      <label className="setting--check">
        <input type="checkbox" checked={withRadii} onChange={(event) => setWithRadii(event.target.checked)} />
        Scale radii, too
      </label>
      <div className="transform__buttons" role="toolbar" aria-label="Transform">
        <Button
          hint="Mirror from left to right"
          shortcut="Shift+H"
          icon={<FlipHorizontal2 size={16} />}
          onClick={() => actions.mirror('x')}
        />
        <Button
          hint="Mirror from top to bottom"
          shortcut="Shift+V"
          icon={<FlipVertical2 size={16} />}
          onClick={() => actions.mirror('y')}
        />
        <Button hint="Repeat…" icon={<Grid3x3 size={16} />} onClick={() => editor.commands.run('object.repeat')} />
      </div>
    </Section>
  );
}
