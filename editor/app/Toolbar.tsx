import { Bug, Circle, CircleDashed, Flame, Gem, Hand, MousePointer2, Sun } from 'lucide-react';
import type { ComponentType } from 'react';
import { DRAGGED_TOOL } from '../canvas/index.ts';
import { useEditor, useSession } from '../context/index.ts';
import { TOOLS, type Tool } from '../session/index.ts';
import { Button } from '../ui/index.ts';

const LOOKS: Readonly<Record<Tool, { Icon: ComponentType<{ size: number }>; name: string; key: string }>> = {
  select: { Icon: MousePointer2, name: 'Select', key: 'V' },
  hand: { Icon: Hand, name: 'Move the view', key: 'G' },
  asteroid: { Icon: Circle, name: 'Asteroid', key: 'A' },
  hot: { Icon: Flame, name: 'Hot asteroid', key: 'H' },
  nova: { Icon: Sun, name: 'Nova', key: 'N' },
  repulsor: { Icon: CircleDashed, name: 'Repulsor', key: 'R' },
  alien: { Icon: Bug, name: 'Alien', key: 'E' },
  mineral: { Icon: Gem, name: 'Mineral', key: 'M' },
};

/** The tools, over the canvas: click one, or drag it to where the object shall be. */
export function Toolbar() {
  const { session, commands } = useEditor();
  const tool = useSession((state) => state.tool);
  const mode = useSession((state) => state.mode);
  if (mode === 'play') return null;
  return (
    <div className="toolbar" role="toolbar" aria-label="Tools">
      {TOOLS.map((name) => {
        const { Icon, name: title, key } = LOOKS[name];
        return (
          <Button
            key={name}
            hint={title}
            shortcut={key}
            icon={<Icon size={17} />}
            pressed={tool === name}
            draggable={name !== 'select' && name !== 'hand'}
            onDragStart={(event) => {
              event.dataTransfer.setData(DRAGGED_TOOL, name);
              event.dataTransfer.effectAllowed = 'copy';
            }}
            onClick={({ detail }) => {
              // pressed by a key: what is next is done by keys, on the canvas
              if (detail === 0) commands.run(`tool.${name}`);
              else session.setState({ tool: name });
            }}
          />
        );
      })}
    </div>
  );
}
