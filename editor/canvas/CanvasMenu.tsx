import { ChevronRight } from 'lucide-react';
import { DropdownMenu } from 'radix-ui';
import type { RefObject } from 'react';
import { type StoreApi, useStore } from 'zustand';
import type { CanvasState, MenuAction, MenuPart } from './canvas-state.ts';

function Action({ title, keys, disabled, run }: MenuAction) {
  return (
    <DropdownMenu.Item className="menu__item" disabled={disabled} onSelect={run}>
      {title}
      {keys !== undefined && <kbd>{keys}</kbd>}
    </DropdownMenu.Item>
  );
}

function Part({ part }: { readonly part: MenuPart }) {
  if (part === null) return <DropdownMenu.Separator className="menu__line" />;
  if (!('entries' in part)) return <Action {...part} />;
  return (
    <DropdownMenu.Sub>
      <DropdownMenu.SubTrigger className="menu__item">
        {part.title}
        <ChevronRight size={14} className="menu__more" aria-hidden />
      </DropdownMenu.SubTrigger>
      <DropdownMenu.Portal>
        <DropdownMenu.SubContent className="menu" collisionPadding={8}>
          {part.entries.map((entry, index) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: two objects may have the same name, and the menu is rebuilt each time
            <Action key={index} {...entry} />
          ))}
        </DropdownMenu.SubContent>
      </DropdownMenu.Portal>
    </DropdownMenu.Sub>
  );
}

interface CanvasMenuProps {
  readonly canvas: StoreApi<CanvasState>;
  /** The element of the canvas. */
  readonly host: RefObject<HTMLElement | null>;
}

/** The menu of a place of the canvas, opened there by the right button, a finger that rests, or the menu key. */
export function CanvasMenu({ canvas, host }: CanvasMenuProps) {
  const menu = useStore(canvas, (state) => state.menu);
  if (menu === null) return null;
  return (
    <DropdownMenu.Root open onOpenChange={(isOpen) => !isOpen && canvas.setState({ menu: null })}>
      <DropdownMenu.Trigger asChild>
        <span className="canvas__menu" aria-hidden style={{ left: menu.screen.x, top: menu.screen.y }} />
      </DropdownMenu.Trigger>
      <DropdownMenu.Portal>
        <DropdownMenu.Content
          className="menu"
          aria-label="Menu of the canvas"
          align="start"
          side="bottom"
          collisionPadding={8}
          onContextMenu={(event) => event.preventDefault()}
          onCloseAutoFocus={(event) => {
            event.preventDefault();
            // an action may have set the focus, as to a field for a name
            if (document.activeElement === document.body) host.current?.focus({ preventScroll: true });
          }}
        >
          {menu.parts.map((part, index) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: lines have no name, and the menu is rebuilt each time
            <Part key={index} part={part} />
          ))}
        </DropdownMenu.Content>
      </DropdownMenu.Portal>
    </DropdownMenu.Root>
  );
}
