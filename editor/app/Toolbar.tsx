import { Hand, Lock, LockOpen, type LucideIcon, MousePointer2 } from 'lucide-react';
import { appearanceOf, placedAs } from '../../schema/index.ts';
import { DRAGGED_TOOL, signOf } from '../canvas/index.ts';
import { useEditor, useSession } from '../core/context/index.ts';
import { titled } from '../core/document/index.ts';
import { chooseTool, TOOLS, type Tool } from '../core/session/index.ts';
import { Button } from '../core/ui/index.ts';

function lookOf(tool: Tool): { readonly Icon: LucideIcon; readonly name: string; readonly key: string | undefined } {
  if (tool === 'select') return { Icon: MousePointer2, name: 'Select', key: 'V' };
  if (tool === 'hand') return { Icon: Hand, name: 'Move the view', key: 'G' };
  const { kind, flag } = placedAs(tool);
  const { one, letter } = appearanceOf(tool);
  return { Icon: signOf(kind, flag !== null).Icon, name: titled(one), key: letter?.toUpperCase() };
}

/**
 * The tools, over the canvas: click one, or drag one to the place for the new object. While the lock is closed, as by a
 * double-click on a tool, the tool stays after placing.
 */
export function Toolbar() {
  const { session, commands } = useEditor();
  const tool = useSession((state) => state.tool);
  const isLocked = useSession((state) => state.isToolLocked);
  const mode = useSession((state) => state.mode);
  if (mode === 'play') return null;
  return (
    <div className="toolbar" role="toolbar" aria-label="Tools">
      {TOOLS.map((name) => {
        const { Icon, name: title, key } = lookOf(name);
        const places = name !== 'select' && name !== 'hand';
        return (
          <Button
            key={name}
            hint={title}
            shortcut={key}
            icon={<Icon size={17} />}
            pressed={tool === name}
            draggable={places}
            className={isLocked && tool === name ? 'toolbar__locked' : ''}
            onDragStart={(event) => {
              event.dataTransfer.setData(DRAGGED_TOOL, name);
              event.dataTransfer.effectAllowed = 'copy';
            }}
            onClick={({ detail }) => {
              // Pressed by the keyboard: the keyboard must now work on the canvas.
              if (detail === 0) commands.run(`tool.${name}`);
              else chooseTool(session, name);
            }}
            onDoubleClick={() => places && session.setState({ tool: name, isToolLocked: true })}
          />
        );
      })}
      <Button
        hint="Keep the tool after placing an object"
        shortcut="Q"
        icon={isLocked ? <Lock size={15} /> : <LockOpen size={15} />}
        pressed={isLocked}
        onClick={() => commands.run('tool.lock')}
      />
    </div>
  );
}
