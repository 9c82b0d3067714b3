! translator.contact_force: F_C = |m1|/R_r + sqrt(f2^2 + f3^2) + 2 sqrt(m2^2 + m3^2)/L
program contact_force
    implicit none
    integer, parameter :: dp = kind(1.d0)
    real(dp) :: f2, f3, m1, m2, m3, rr, l, f_torq, f_rad, f_bend, bend, jac(7)
    integer :: status
    do
        read (*, *, iostat=status) f2, f3, m1, m2, m3, rr, l
        if (status /= 0) exit
        if (.not. (rr >= 0 .and. l >= 0) .or. abs(f2 + f3 + m1 + m2 + m3 + rr + l) > huge(1.d0) .or. f2 + f3 + m1 + m2 + m3 &
            /= f2 + f3 + m1 + m2 + m3) then
            write (*, '(a)') 'refuse'
            flush (6)
            cycle
        end if
        jac = 0
        f_torq = 0
        if (rr > 0) then
            f_torq = abs(m1)/rr
            if (m1 /= 0) jac(3) = sign(1.d0, m1)/rr
            jac(6) = -f_torq/rr
        end if
        f_rad = sqrt(f2**2 + f3**2)
        if (f_rad > 0) then
            jac(1) = f2/f_rad
            jac(2) = f3/f_rad
        end if
        bend = sqrt(m2**2 + m3**2)
        f_bend = 0
        if (l > 0) then
            f_bend = 2*bend/l
            if (bend > 0) then
                jac(4) = 2*m2/(bend*l)
                jac(5) = 2*m3/(bend*l)
            end if
            jac(7) = -f_bend/l
        end if
        write (*, '(*(es25.16e3))') f_torq + f_rad + f_bend, jac
        flush (6)
    end do
end program contact_force
