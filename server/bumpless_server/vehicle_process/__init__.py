"""The vehicle node as a child process: started, watched, started again."""
