import { Gamepad2 } from 'lucide-react';
import { useEditor } from '../context/index.ts';
import { Button } from '../ui/index.ts';

/** The way out of a list that is empty because nobody has played the level. */
export function PlayButton() {
  const { commands } = useEditor();
  return (
    <Button
      hint="Play from the start"
      shortcut="Space"
      look="main"
      icon={<Gamepad2 size={15} />}
      onClick={() => commands.run('play.start')}
    >
      Play the level
    </Button>
  );
}
