import { HeartPulse } from 'lucide-react';
import { useStore } from 'zustand';
import { useEditor } from '../../core/context/index.ts';
import { Button } from '../../core/ui/index.ts';

/** Turns it on or off that a change of the level re-times the shown run. */
export function AliveToggle() {
  const { settings, commands } = useEditor();
  const isOn = useStore(settings, ({ keepAlive }) => keepAlive);
  return (
    <Button
      hint={`Keep the run alive: ${isOn ? 'on. A change that breaks it re-times its holds' : 'off'}`}
      shortcut="Shift K"
      icon={<HeartPulse size={16} />}
      pressed={isOn}
      aria-label="Keep the run alive"
      onClick={() => commands.run('run.keep-alive')}
    />
  );
}
