import { useEffect, useState } from 'react';

/** Whether a gamepad has been used since this component was shown; browsers hide gamepads until then. */
export function useGamepad(): boolean {
  const [count, setCount] = useState(0);
  useEffect(() => {
    const look = () => setCount(navigator.getGamepads?.().filter((pad) => pad !== null).length ?? 0);
    look();
    window.addEventListener('gamepadconnected', look);
    window.addEventListener('gamepaddisconnected', look);
    return () => {
      window.removeEventListener('gamepadconnected', look);
      window.removeEventListener('gamepaddisconnected', look);
    };
  }, []);
  return count > 0;
}
